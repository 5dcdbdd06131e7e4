package org.palpate.imagej;

import ij.IJ;
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
      IJ.error(title, e.getMessage());
    }
  }
}
