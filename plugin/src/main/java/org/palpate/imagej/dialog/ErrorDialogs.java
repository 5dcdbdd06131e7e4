package org.palpate.imagej.dialog;

import ij.IJ;
import ij.Macro;
import org.palpate.imagej.stack.TouchRefusedException;

/**
 * Shows errors in dialogs, in plain words. The stack trace is shown if ImageJ's debug mode is on
 * (Edit &gt; Options &gt; Misc). Any thread.
 */
public final class ErrorDialogs {
  private ErrorDialogs() {}

  /** Shows a refusal or an unexpected failure. */
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
            + ").\n"
            + "Tick \"Debug mode\" in Edit > Options > Misc, try again, and report the output.");
  }

  /** Reports that the memory is too small. */
  public static void showOutOfMemory(String title) {
    clearStatus();
    IJ.error(
        title,
        "There is not enough memory: give ImageJ more by Edit > Options > Memory & Threads...");
  }

  /** Clears ImageJ's progress bar and status line. */
  private static void clearStatus() {
    IJ.showProgress(1);
    IJ.showStatus("");
  }

  /** Whether ImageJ ends a macro with this exception. */
  public static boolean endsMacro(RuntimeException e) {
    return Macro.MACRO_CANCELED.equals(e.getMessage());
  }
}
