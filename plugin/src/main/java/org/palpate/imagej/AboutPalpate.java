package org.palpate.imagej;

import ij.IJ;

/** "About Palpate": shows the purpose, the version and the safety notice. */
public final class AboutPalpate extends PalpateCommand {
  /** Creates the command; ImageJ calls this. */
  public AboutPalpate() {
    super("About Palpate");
  }

  @Override
  void execute() {
    String version = AboutPalpate.class.getPackage().getImplementationVersion();
    IJ.showMessage(
        "About Palpate",
        "Palpate "
            + (version == null ? "(not packed)" : version)
            + "\nTouch a segmented 3-D scan with a haptic device.\n"
            + "After Vlasov, Friese and Wolter, 2013. Apache License 2.0.\n \n"
            + "Not a medical device. Not yet tested on haptic hardware.");
  }
}
