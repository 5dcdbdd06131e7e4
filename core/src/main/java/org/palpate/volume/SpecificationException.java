package org.palpate.volume;

/** Refuses a text that was to specify something. The message is {@code WHAT: WHERE: what to do}. */
public final class SpecificationException extends IllegalArgumentException {
  private static final long serialVersionUID = 1L;

  private final String what;
  private final String remedy;

  /**
   * Creates the exception.
   *
   * @param what what is wrong
   * @param where the text or the value in it that is wrong
   * @param remedy what to write instead
   */
  public SpecificationException(String what, String where, String remedy) {
    super(what + ": " + where + ": " + remedy);
    this.what = what;
    this.remedy = remedy;
  }

  /** {@return what is wrong} */
  public String what() {
    return what;
  }

  /** {@return what to write instead} */
  public String remedy() {
    return remedy;
  }
}
