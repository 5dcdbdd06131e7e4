package org.palpate.imagej;

import ij.IJ;
import java.util.List;
import java.util.Optional;
import org.palpate.host.SessionView;
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
  void execute() throws StackRefused {
    Sessions.refuseSecond();
    StackVolume volume = StackVolume.shownIn(IJ.getImage());
    if (!volume.isOneOfSeveral() || asksFor(volume)) {
      TouchOptions options = TouchOptions.ask("Touch Volume", volume, true);
      if (options != null) {
        TouchRun.begin(volume, options, Optional.empty());
      }
    }
  }

  /** Asks whether the shown channel and time is meant. */
  static boolean asksFor(StackVolume volume) {
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
    return Boolean.toString(Sessions.isRunning());
  }

  /**
   * For macros: the segments of the session that runs, a line each, name and voxels parted by a
   * tabulator; empty where none runs.
   */
  public static String segments() {
    try {
      StackSession session = Sessions.current();
      List<Segment> segments = session.segments();
      StringBuilder lines = new StringBuilder();
      for (int n = 0; n < segments.size(); n++) {
        lines.append(segments.get(n).name()).append('\t').append(session.voxels(n)).append('\n');
      }
      return lines.toString();
    } catch (StackRefused e) {
      return "";
    }
  }

  /** For macros: frames so far, "0" where no session runs. */
  public static String frames() {
    try {
      return Long.toString(Sessions.current().status().frames());
    } catch (StackRefused e) {
      return "0";
    }
  }

  /** For macros: pictures drawn in the 3-D window so far, "0" where there is none. */
  public static String redraws() {
    try {
      return Long.toString(Sessions.current().view().map(SessionView::redraws).orElse(0L));
    } catch (StackRefused e) {
      return "0";
    }
  }
}
