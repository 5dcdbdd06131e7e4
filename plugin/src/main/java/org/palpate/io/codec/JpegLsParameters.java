package org.palpate.io.codec;

/**
 * The parameters of a scan of JPEG-LS.
 *
 * <p>Source: ITU-T T.87, A.2.1, C.2.4.1.1.
 *
 * @param most the largest value of a pixel
 * @param near the largest error of a pixel, 0 if lossless
 * @param threshold1 the first threshold of local gradients
 * @param threshold2 the second threshold
 * @param threshold3 the third threshold
 * @param reset the count at which the statistics of a context are halved
 */
record JpegLsParameters(
    int most, int near, int threshold1, int threshold2, int threshold3, int reset) {
  private static final int DEFAULT_RESET = 64;

  /** Returns the parameters that a stream has if it states none. */
  static JpegLsParameters defaults(int most, int near) {
    int[] basic = {3, 7, 21};
    int[] thresholds = new int[3];
    int least = near + 1;
    for (int n = 0; n < 3; n++) {
      int wanted;
      if (most >= 128) {
        int factor = (Math.min(most, 4095) + 128) / 256;
        wanted = factor * (basic[n] - (n + 2)) + (n + 2) + (2 * n + 3) * near;
      } else {
        wanted = Math.max(n + 2, basic[n] / (256 / (most + 1)) + (2 * n + 3) * near);
      }
      thresholds[n] = wanted > most || wanted < least ? least : wanted;
      least = thresholds[n];
    }
    return new JpegLsParameters(
        most, near, thresholds[0], thresholds[1], thresholds[2], DEFAULT_RESET);
  }

  /** Returns the step between values that the code distinguishes. */
  int step() {
    return 2 * near + 1;
  }

  /** Returns how many different prediction errors there are. */
  int range() {
    return (most + 2 * near) / step() + 1;
  }

  /** Returns the number of bits of a prediction error that is written without a Golomb code. */
  int errorBits() {
    return bitsFor(range());
  }

  /** Returns the largest number of bits that a prediction error takes. */
  int limit() {
    int bits = Math.max(2, bitsFor(most + 1));
    return 2 * (bits + Math.max(8, bits));
  }

  /** Returns the number of bits that number {@code count} values. */
  private static int bitsFor(int count) {
    return 32 - Integer.numberOfLeadingZeros(count - 1);
  }
}
