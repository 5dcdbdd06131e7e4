package org.palpate.sync;

/**
 * What an {@link Accumulator} has carried so far.
 *
 * @param writes changes of a property's value in the haptic thread, as of the last publication that
 *     was taken; a set to the same value is none
 * @param publications frames that changed anything
 * @param applied properties that the reader applied to the scene
 */
public record SyncCounts(long writes, long publications, long applied) {}
