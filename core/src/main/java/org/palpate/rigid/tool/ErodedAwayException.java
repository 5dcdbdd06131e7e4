package org.palpate.rigid.tool;

/** Says that no point of a tool is as deep as the erosion that was asked for. */
public final class ErodedAwayException extends IllegalArgumentException {
  private static final long serialVersionUID = 1L;

  ErodedAwayException(double depthMm) {
    super("no point of the tool lies deeper than " + depthMm + " mm below its surface");
  }
}
