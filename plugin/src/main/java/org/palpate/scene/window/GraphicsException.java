package org.palpate.scene.window;

/** Nothing can be drawn here: no display, no driver, too old a driver. */
public final class GraphicsException extends Exception {
  private static final long serialVersionUID = 1L;

  private final String what;
  private final String remedy;

  GraphicsException(String what, String remedy, Throwable cause) {
    super(what + ": " + remedy, cause);
    this.what = what;
    this.remedy = remedy;
  }

  /** What is wrong, in a few words. */
  public String what() {
    return what;
  }

  /** What to do about it. */
  public String remedy() {
    return remedy;
  }
}
