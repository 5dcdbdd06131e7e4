package org.palpate.sync;

/**
 * What an {@link Accumulator} has carried so far.
 *
 * @param writes changes of a property's value in the haptic thread, as of the last publication that
 *     was taken; a set to the same value is none
 * @param unchanged frames in which no value changed, so that nothing was handed over; right once
 *     the writer has ended
 * @param publications frames that changed anything
 * @param applied properties that the reader applied to the scene
 */
public record SyncCounters(long writes, long unchanged, long publications, long applied) {}
