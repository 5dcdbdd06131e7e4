package org.palpate.volume.fracture;

import org.palpate.volume.SpecificationException;

/**
 * The specification of a synthetic fracture.
 *
 * @param parts the number of fragments, {@link #MIN_PARTS} to {@link #MAX_PARTS}
 * @param seed selects the fracture surfaces and the displacements
 * @param kerfVoxels the voxels that a saw takes away between two fragments, 0 to {@link #MAX_KERF}
 */
public record FractureSpec(int parts, long seed, int kerfVoxels) {
  /** The smallest number of fragments. */
  public static final int MIN_PARTS = 2;

  /** The largest number of fragments. */
  public static final int MAX_PARTS = 8;

  /** The widest saw cut, voxels. */
  public static final int MAX_KERF = 4;

  /** The seed of a specification that names none. */
  public static final long DEFAULT_SEED = 1;

  /** The saw cut of a specification that names none, voxels. */
  public static final int DEFAULT_KERF = 1;

  /**
   * Checks the numbers.
   *
   * @throws SpecificationException if one is out of range; the message names what to choose
   */
  public FractureSpec {
    if (parts < MIN_PARTS || parts > MAX_PARTS) {
      throw new SpecificationException(
          "number of fragments out of range",
          Integer.toString(parts),
          "choose " + MIN_PARTS + " to " + MAX_PARTS);
    }
    if (kerfVoxels < 0 || kerfVoxels > MAX_KERF) {
      throw new SpecificationException(
          "saw kerf out of range",
          Integer.toString(kerfVoxels),
          "choose 0 to " + MAX_KERF + " voxels");
    }
  }

  /**
   * {@return what {@code PARTS[:SEED[:KERF]]} specifies, as in {@code 4:7:0}}
   *
   * @param text the text of a user
   * @throws SpecificationException if the text has another form; the message says what to write
   */
  public static FractureSpec parse(String text) {
    String[] words = text.split(":", -1);
    if (words.length > 3) {
      throw refusal(text);
    }
    return new FractureSpec(
        (int) number(words[0], 9, text),
        words.length > 1 ? number(words[1], 18, text) : DEFAULT_SEED,
        words.length > 2 ? (int) number(words[2], 9, text) : DEFAULT_KERF);
  }

  private static long number(String word, int mostDigits, String text) {
    if (word.isEmpty()
        || word.length() > mostDigits
        || !word.chars().allMatch(c -> c >= '0' && c <= '9')) {
      throw refusal(text);
    }
    return Long.parseLong(word);
  }

  private static SpecificationException refusal(String text) {
    return new SpecificationException(
        "fracture not understood",
        "'" + text + "'",
        "write PARTS[:SEED[:KERF]], for example 4:7:1");
  }

  @Override
  public String toString() {
    return parts + ":" + seed + ":" + kerfVoxels;
  }
}
