package org.palpate.imagej;

import ij.plugin.PlugIn;
import org.palpate.imagej.dialog.ErrorDialogs;
import org.palpate.imagej.stack.TouchRefusedException;

/**
 * A command of the menu; shows a refusal or failure in a dialog. On ImageJ's thread for the
 * command.
 */
abstract class PalpateCommand implements PlugIn {
  private final String title;

  PalpateCommand(String title) {
    this.title = title;
  }

  /** Executes the command. */
  abstract void execute() throws TouchRefusedException;

  @Override
  public final void run(String argument) {
    try {
      execute();
    } catch (TouchRefusedException e) {
      ErrorDialogs.show(title, e);
    } catch (RuntimeException e) {
      if (ErrorDialogs.endsMacro(e)) {
        throw e;
      }
      ErrorDialogs.show(title, e);
    } catch (OutOfMemoryError e) {
      ErrorDialogs.showOutOfMemory(title);
    } catch (NoClassDefFoundError e) {
      ErrorDialogs.show(title, missingLibrary(e));
    }
  }

  /** Explains that the thin jar runs without JOGL and JNA. */
  private static TouchRefusedException missingLibrary(NoClassDefFoundError e) {
    return new TouchRefusedException(
        "A library is missing ("
            + e.getMessage()
            + "): Palpate_.jar is for Fiji; plain ImageJ needs Palpate_bundle_.jar instead.");
  }
}
