package org.palpate.imagej.dialog;

import ij.IJ;
import ij.Macro;
import org.palpate.imagej.stack.TouchRefusedException;

/**
 * Says what went wrong in a dialog, in plain words. The stack trace is shown where ImageJ's debug
 * mode is on (Edit &gt; Options &gt; Misc).
 */
public final class ErrorDialogs {
  private ErrorDialogs() {}

  /** Shows a refusal, or a failure that no one foresaw. Any thread. */
  public static void show(String title, Exception failure) {
    clearStatus();
    if (failure instanceof TouchRefusedException) {
      IJ.error(title, failure.getMessage());
      return;
    }
    if (IJ.debugMode) {
      IJ.handleException(failure);
    }
    IJ.error(
        title,
        "Palpate failed ("
            + failure
            + ").\nTick \"Debug mode\" in Edit > Options > Misc, try again, and report what is shown.");
  }

  /** Says that the memory does not suffice. Any thread. */
  public static void showOutOfMemory(String title) {
    clearStatus();
    IJ.error(
        title,
        "There is not enough memory: give ImageJ more by Edit > Options > Memory & Threads...");
  }

  /** What was being done is done no more. */
  private static void clearStatus() {
    IJ.showProgress(1);
    IJ.showStatus("");
  }

  /** Whether this is how ImageJ ends a macro. */
  public static boolean endsMacro(RuntimeException e) {
    return Macro.MACRO_CANCELED.equals(e.getMessage());
  }
}
