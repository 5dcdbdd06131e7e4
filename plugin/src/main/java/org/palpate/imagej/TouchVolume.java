package org.palpate.imagej;

import ij.IJ;
import java.util.List;
import java.util.Optional;
import org.palpate.host.SessionView;
import org.palpate.imagej.dialog.TouchOptions;
import org.palpate.imagej.session.CurrentSession;
import org.palpate.imagej.session.StackSession;
import org.palpate.imagej.session.StackSessionRunner;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.volume.Segment;

/**
 * "Touch Volume...": touches the active stack until the user presses Escape or calls "Stop
 * Touching", the time is over, or the image or the 3-D window closes. It returns as soon as the
 * force is on.
 *
 * <p>Macros call the static methods, for example {@code
 * call("org.palpate.imagej.TouchVolume.isTouching")}. Their names are a public interface.
 */
public final class TouchVolume extends PalpateCommand {
  /** Creates the command; ImageJ calls this. */
  public TouchVolume() {
    super("Touch Volume");
  }

  @Override
  void execute() throws TouchRefusedException {
    CurrentSession.requireNoneRunning();
    StackVolume volume = StackVolume.shownIn(IJ.getImage());
    if (!volume.hasMoreChannelsOrTimes() || confirmShownChannel(volume)) {
      TouchOptions options = TouchOptions.ask("Touch Volume", volume, true);
      if (options != null) {
        StackSessionRunner.begin(volume, options, Optional.empty());
      }
    }
  }

  /** Asks the user whether the shown channel and time is meant. */
  static boolean confirmShownChannel(StackVolume volume) {
    return IJ.showMessageWithCancel(
        "Palpate",
        "The image has several channels or times.\nChannel "
            + volume.channel()
            + " at time "
            + volume.frame()
            + ", the one that is shown, will be touched.");
  }

  /** Returns "true" while a session runs, else "false". */
  public static String isTouching() {
    return Boolean.toString(CurrentSession.isRunning());
  }

  /**
   * Returns the segments of the running session, one a line: name, tab, number of voxels. Empty if
   * none runs.
   */
  public static String segments() {
    try {
      StackSession session = CurrentSession.current();
      List<Segment> segments = session.segments();
      StringBuilder lines = new StringBuilder();
      for (int n = 0; n < segments.size(); n++) {
        lines.append(segments.get(n).name()).append('\t').append(session.voxels(n)).append('\n');
      }
      return lines.toString();
    } catch (TouchRefusedException e) {
      return "";
    }
  }

  /** Returns the number of frames so far; "0" if no session runs. */
  public static String frames() {
    try {
      return Long.toString(CurrentSession.current().status().frames());
    } catch (TouchRefusedException e) {
      return "0";
    }
  }

  /** Returns the number of pictures drawn in the 3-D window so far; "0" if there is no window. */
  public static String redraws() {
    try {
      return Long.toString(CurrentSession.current().view().map(SessionView::redraws).orElse(0L));
    } catch (TouchRefusedException e) {
      return "0";
    }
  }
}
