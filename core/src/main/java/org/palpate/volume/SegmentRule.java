package org.palpate.volume;

/**
 * A segment that a person asked for, as in {@code bone=>=1500}.
 *
 * @param name of the segment, unique among those asked for
 * @param rule which values belong to it
 */
public record SegmentRule(String name, ValueRule rule) {}
