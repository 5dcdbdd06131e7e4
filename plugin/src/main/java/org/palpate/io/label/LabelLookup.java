package org.palpate.io.label;

import java.util.List;
import java.util.Optional;
import org.palpate.io.label.SegmentSpec.Labels;
import org.palpate.io.volume.VoxelSlice;

/**
 * Maps each label to its segment, so that a hundred segments cost no more than one. Works for rules
 * that are lists of labels, with no label in two lists.
 */
final class LabelLookup {
  private static final int MAX_LABELS = 1 << 16;

  private final SegmentAccumulator[] layerOfLabel;

  private LabelLookup(SegmentAccumulator[] layerOfLabel) {
    this.layerOfLabel = layerOfLabel;
  }

  /** Returns a lookup for the rules, if they allow one. */
  static Optional<LabelLookup> of(List<SegmentSpec> specs, List<SegmentAccumulator> layers) {
    SegmentAccumulator[] layerOfLabel = new SegmentAccumulator[MAX_LABELS];
    for (int n = 0; n < specs.size(); n++) {
      if (!(specs.get(n).rule() instanceof Labels labels)) {
        return Optional.empty();
      }
      for (long label : labels.sorted()) {
        if (label < 0 || label >= MAX_LABELS || layerOfLabel[(int) label] != null) {
          return Optional.empty();
        }
        layerOfLabel[(int) label] = layers.get(n);
      }
    }
    return Optional.of(new LabelLookup(layerOfLabel));
  }

  /** Adds slice k to the segments. */
  void addSlice(int k, VoxelSlice slice) {
    int[] values = slice.integers();
    for (int j = 0; j < slice.sizeY(); j++) {
      int row = j * slice.sizeX();
      for (int i = 0; i < slice.sizeX(); i++) {
        int value = values[row + i];
        SegmentAccumulator layer = (value & -MAX_LABELS) == 0 ? layerOfLabel[value] : null;
        if (layer != null) {
          layer.mark(i, j, k);
        }
      }
    }
  }
}
