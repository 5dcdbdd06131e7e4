package org.palpate.volume.phantom;

/**
 * Reads a phantom slice by slice, like a file. It generates four slices at a time, so that
 * ascending order is cheapest. Keeps scratch: one thread an instance.
 */
public final class PhantomSlices {
  private static final int SLICES_A_LAYER = 4;
  private static final int NONE = -1;

  private final PhantomBrickWriter writer;
  private final int edge;
  private final boolean grey;
  private final short[] layer;
  private int layerIndex = NONE;

  PhantomSlices(PhantomBrickWriter writer, int edge, boolean grey) {
    this.writer = writer;
    this.edge = edge;
    this.grey = grey;
    layer = new short[SLICES_A_LAYER * edge * edge];
  }

  /**
   * Writes slice k into {@code dest}, x fastest.
   *
   * @param k the slice, from 0 to the edge, not included
   * @param dest receives edge * edge values from 0 to {@link Phantom#SOLID_GREY}
   * @throws IllegalArgumentException if there is no such slice, or {@code dest} is too short
   */
  public void read(int k, short[] dest) {
    if (k < 0 || k >= edge || dest.length < edge * edge) {
      throw new IllegalArgumentException(
          "no such slice or too little room: k=" + k + " edge=" + edge + " room=" + dest.length);
    }
    if (k / SLICES_A_LAYER != layerIndex) {
      layerIndex = k / SLICES_A_LAYER;
      writer.writeLayer(layerIndex, grey, layer);
    }
    System.arraycopy(layer, k % SLICES_A_LAYER * edge * edge, dest, 0, edge * edge);
  }
}
