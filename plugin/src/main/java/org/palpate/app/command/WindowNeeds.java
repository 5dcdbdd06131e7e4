package org.palpate.app.command;

import java.util.List;
import org.palpate.app.options.SurfaceOptions;
import org.palpate.app.process.PalpateException;
import org.palpate.scene.window.GraphicsDriver;
import picocli.CommandLine.ParseResult;

/**
 * Refuses options that need a window if there is none.
 *
 * @param headless whether the user wants no window
 */
record WindowNeeds(boolean headless) {
  /** Options that have no effect without a window. */
  private static final List<String> OPTIONS =
      List.of("--slices", "--surface", "--clip", SurfaceOptions.DEFORMED, "--upside-down");

  /**
   * Checks all options that have no effect without a window.
   *
   * @throws PalpateException exit code 2, if one was given and no window is wanted
   */
  void check(ParseResult given) {
    for (String option : OPTIONS) {
      if (headless && given.hasMatchedOption(option)) {
        throw needsWindow(option);
      }
    }
  }

  /**
   * Checks an option that cannot work without a window.
   *
   * @param isGiven whether it was given
   * @throws PalpateException exit code 2, if it was, and there is no window or no display
   */
  void check(String option, boolean isGiven) {
    if (isGiven && headless) {
      throw needsWindow(option);
    }
    if (isGiven && !GraphicsDriver.hasDisplay()) {
      throw PalpateException.wrongUse(
          option + " needs a window, but there is no display",
          option,
          "set DISPLAY, or leave it out");
    }
  }

  private static PalpateException needsWindow(String option) {
    return PalpateException.wrongUse(
        option + " needs a window", "--headless", "leave one of them out");
  }
}
