package org.palpate.imagej;

import ij.plugin.PlugIn;

/** A command of the menu: says in a dialog, in plain words, what could not be done. */
abstract class PalpateCommand implements PlugIn {
  private final String title;

  PalpateCommand(String title) {
    this.title = title;
  }

  /** Does what the command is for, in ImageJ's thread for it. */
  abstract void execute() throws StackRefused;

  @Override
  public final void run(String argument) {
    try {
      execute();
    } catch (StackRefused e) {
      PlainErrors.show(title, e);
    } catch (RuntimeException e) {
      if (PlainErrors.endsMacro(e)) {
        throw e;
      }
      PlainErrors.show(title, e);
    } catch (OutOfMemoryError e) {
      PlainErrors.showOutOfMemory(title);
    } catch (NoClassDefFoundError e) {
      PlainErrors.show(title, missing(e));
    }
  }

  /** The thin jar where JOGL and JNA are not. */
  private static StackRefused missing(NoClassDefFoundError e) {
    return new StackRefused(
        "A library is missing ("
            + e.getMessage()
            + "): Palpate_.jar is for Fiji; plain ImageJ needs Palpate_bundle_.jar instead.");
  }
}
