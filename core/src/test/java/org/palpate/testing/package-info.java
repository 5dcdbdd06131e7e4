/**
 * Helpers that the tests of several modules share: seeds, scans, hostile input, exact oracles, a
 * floor.
 */
package org.palpate.testing;
