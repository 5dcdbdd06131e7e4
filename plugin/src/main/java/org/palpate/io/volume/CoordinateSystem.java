package org.palpate.io.volume;

/** The directions of a file's world axes in the patient. */
public enum CoordinateSystem {
  LPS("x to the left, y to the back, z to the head (LPS)"),
  RAS("x to the right, y to the front, z to the head (RAS)"),
  LAS("x to the left, y to the front, z to the head (LAS)"),
  UNKNOWN("axes not named by the file");

  private final String description;

  CoordinateSystem(String description) {
    this.description = description;
  }

  /** Returns the directions in words, as the info command prints them. */
  public String description() {
    return description;
  }
}
