package org.palpate.io.volume;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/**
 * Names and colours of label values.
 *
 * @param labels by value, ascending
 * @param isComplete whether the volume itself lists its segments, so that a segment without a voxel
 *     is reported
 */
public record LabelTable(Map<Long, Label> labels, boolean isComplete) {
  /** The table without names, which says only that the values are labels. */
  public static final LabelTable EMPTY = new LabelTable(Map.of());

  /** Copies the labels. */
  public LabelTable {
    labels = Collections.unmodifiableMap(new TreeMap<>(labels));
  }

  /** Creates the table of a file beside the volume, which may name labels that do not occur. */
  public LabelTable(Map<Long, Label> labels) {
    this(labels, false);
  }

  /**
   * A name and a colour.
   *
   * @param name the name as the table has it
   * @param rgb 0xRRGGBB
   */
  public record Label(String name, int rgb) {}
}
