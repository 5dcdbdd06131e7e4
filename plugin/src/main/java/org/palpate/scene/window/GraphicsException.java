package org.palpate.scene.window;

/** Drawing is impossible on this machine: no display, no driver, or a driver that is too old. */
public final class GraphicsException extends Exception {
  private static final long serialVersionUID = 1L;

  private final String what;
  private final String remedy;

  GraphicsException(String what, String remedy, Throwable cause) {
    super(what + ": " + remedy, cause);
    this.what = what;
    this.remedy = remedy;
  }

  /** Returns what is wrong, in a few words. */
  public String what() {
    return what;
  }

  /** Returns the remedy. */
  public String remedy() {
    return remedy;
  }
}
