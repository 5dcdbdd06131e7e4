package org.palpate.io.tiff;

import java.util.Arrays;

/** The page of each plane of a stack with channels and times. */
final class PlaneTable {
  private final int slices;
  private final int channels;
  private final int times;

  /** The page of slice z, channel c, time t at (t * channels + c) * slices + z; -1 for none. */
  private final int[] pages;

  /** Creates a table without pages. */
  PlaneTable(int slices, int channels, int times) {
    this.slices = slices;
    this.channels = channels;
    this.times = times;
    pages = new int[slices * channels * times];
    Arrays.fill(pages, -1);
  }

  /** Returns a table whose pages follow one another: channels first, then slices, then times. */
  static PlaneTable channelsFirst(int slices, int channels, int times) {
    PlaneTable table = new PlaneTable(slices, channels, times);
    for (int n = 0; n < table.pages.length; n++) {
      int z = n % slices;
      int c = n / slices % channels;
      int t = n / slices / channels;
      table.pages[n] = (t * slices + z) * channels + c;
    }
    return table;
  }

  /** Sets the page of a plane. */
  void setPage(int z, int channel, int time, int page) {
    pages[(time * channels + channel) * slices + z] = page;
  }

  /** Returns the number of planes along z. */
  int slices() {
    return slices;
  }

  /** Returns the number of channels. */
  int channels() {
    return channels;
  }

  /** Returns the number of times. */
  int times() {
    return times;
  }

  /** Returns the number of planes. */
  int planes() {
    return pages.length;
  }

  /** Returns the number of stacks to choose from. */
  int stacks() {
    return channels * times;
  }

  /** Returns what there is to choose from, in words. */
  String description() {
    if (times == 1) {
      return channels + " channels of " + slices + " slices";
    }
    return times
        + " times of "
        + slices
        + " slices"
        + (channels == 1
            ? ""
            : " in " + channels + " channels (step = " + channels + " x time + channel)");
  }

  /** Returns the page of a slice in a stack, counted as {@code time * channels + channel}. */
  int page(int stack, int z) {
    return pages[stack * slices + z];
  }

  /** Returns the number of planes that have no page among the first ones. */
  long missing(int pageCount) {
    return Arrays.stream(pages).filter(page -> page < 0 || page >= pageCount).count();
  }
}
