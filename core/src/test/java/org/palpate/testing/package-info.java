/**
 * Helpers that the tests of several modules share: seeds, hostile input, exact oracles, a floor.
 */
package org.palpate.testing;
