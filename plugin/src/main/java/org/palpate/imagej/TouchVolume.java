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
 * "Touch Volume...": touches the stack in front until Escape, "Stop Touching", the end of its time,
 * or the image or the 3-D window closes. Returns as soon as force is on.
 *
 * <p>Macros may ask meanwhile, as in {@code call("org.palpate.imagej.TouchVolume.isTouching")}.
 */
public final class TouchVolume extends PalpateCommand {
  /** Made by ImageJ. */
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

  /** Asks whether the shown channel and time is meant. */
  static boolean confirmShownChannel(StackVolume volume) {
    return IJ.showMessageWithCancel(
        "Palpate",
        "The image has several channels or times.\nChannel "
            + volume.channel()
            + " at time "
            + volume.frame()
            + ", the one that is shown, will be touched.");
  }

  /** For macros: "true" while a session runs, else "false". */
  public static String isTouching() {
    return Boolean.toString(CurrentSession.isRunning());
  }

  /**
   * For macros: the segments of the session that runs, a line each, name and voxels parted by a
   * tabulator; empty where none runs.
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

  /** For macros: frames so far, "0" where no session runs. */
  public static String frames() {
    try {
      return Long.toString(CurrentSession.current().status().frames());
    } catch (TouchRefusedException e) {
      return "0";
    }
  }

  /** For macros: pictures drawn in the 3-D window so far, "0" where there is none. */
  public static String redraws() {
    try {
      return Long.toString(CurrentSession.current().view().map(SessionView::redraws).orElse(0L));
    } catch (TouchRefusedException e) {
      return "0";
    }
  }
}
