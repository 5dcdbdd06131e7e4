/** What tests of several modules share: seeds, the exact oracle of geometry. */
package org.palpate.testing;
