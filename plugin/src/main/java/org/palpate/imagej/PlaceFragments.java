package org.palpate.imagej;

import ij.IJ;
import org.palpate.imagej.dialog.PlaceOptions;
import org.palpate.imagej.session.CurrentSession;
import org.palpate.imagej.session.StackSessionRunner;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;

/**
 * "Place Fragments...": takes the labels of the active stack as fragments of a bone, which a hand
 * takes, moves and puts down. It ends as "Touch Volume..." does, and then shows a new label stack.
 *
 * <p>Macros call the static methods, for example {@code
 * call("org.palpate.imagej.PlaceFragments.move", "label 2", "1,2,3,1,0,0,0")}. Their names are a
 * public interface.
 */
public final class PlaceFragments extends PalpateCommand {
  /** Creates the command; ImageJ calls this. */
  public PlaceFragments() {
    super("Place Fragments");
  }

  @Override
  void execute() throws TouchRefusedException {
    CurrentSession.requireNoneRunning();
    StackVolume volume = StackVolume.shownIn(IJ.getImage());
    if (!volume.hasMoreChannelsOrTimes() || TouchVolume.confirmShownChannel(volume)) {
      PlaceOptions options = PlaceOptions.ask();
      if (options != null) {
        StackSessionRunner.begin(volume, options);
      }
    }
  }

  /**
   * Moves a fragment towards a pose, as far as others let it.
   *
   * @param pose from its place in the stack: x,y,z in mm, then the quaternion qw,qx,qy,qz
   * @return an empty text, or why it cannot move
   */
  public static String move(String fragment, String pose) {
    try {
      CurrentSession.placing().move(fragment, pose);
      return "";
    } catch (TouchRefusedException e) {
      return e.getMessage();
    }
  }

  /** Returns the pose of a fragment as {@link #move} takes it, or why there is none. */
  public static String pose(String fragment) {
    try {
      return CurrentSession.placing().pose(fragment);
    } catch (TouchRefusedException e) {
      return e.getMessage();
    }
  }
}
