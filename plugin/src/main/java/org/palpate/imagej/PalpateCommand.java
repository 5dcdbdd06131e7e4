package org.palpate.imagej;

import ij.plugin.PlugIn;
import org.palpate.imagej.dialog.ErrorDialogs;
import org.palpate.imagej.stack.TouchRefusedException;

/** A command of the menu: says in a dialog, in plain words, what could not be done. */
abstract class PalpateCommand implements PlugIn {
  private final String title;

  PalpateCommand(String title) {
    this.title = title;
  }

  /** Does what the command is for, in ImageJ's thread for it. */
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
      ErrorDialogs.show(title, missing(e));
    }
  }

  /** The thin jar where JOGL and JNA are not. */
  private static TouchRefusedException missing(NoClassDefFoundError e) {
    return new TouchRefusedException(
        "A library is missing ("
            + e.getMessage()
            + "): Palpate_.jar is for Fiji; plain ImageJ needs Palpate_bundle_.jar instead.");
  }
}
