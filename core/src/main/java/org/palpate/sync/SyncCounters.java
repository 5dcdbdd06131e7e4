package org.palpate.sync;

/**
 * A copy of the counters of an {@link Accumulator}.
 *
 * @param writes changes of a property's value by the writer, as of the last publication that was
 *     taken; a set to the same value is no change
 * @param unchanged frames without any change, which published nothing; exact once the writer has
 *     ended
 * @param publications frames with a change
 * @param applied properties that the reader applied to the scene
 */
public record SyncCounters(long writes, long unchanged, long publications, long applied) {}
