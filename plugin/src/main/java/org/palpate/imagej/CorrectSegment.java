package org.palpate.imagej;

import ij.IJ;
import ij.Prefs;
import ij.gui.GenericDialog;
import java.util.ArrayDeque;
import java.util.Deque;
import org.palpate.geometry.Vec3;

/**
 * "Correct Segment...": adds or removes the voxels of a ball around the interaction point, in the
 * stack and in what is felt, or undoes and redoes that. The stack is what is kept: save it to keep
 * the correction.
 */
public final class CorrectSegment extends PalpateCommand {
  private static final String ADD = "add";
  private static final String REMOVE = "remove";
  private static final String UNDO = "undo";
  private static final String REDO = "redo";
  private static final int KEPT_STROKES = 100;

  private static final Deque<BrushStroke> DONE = new ArrayDeque<>();
  private static final Deque<BrushStroke> UNDONE = new ArrayDeque<>();

  /** Made by ImageJ. */
  public CorrectSegment() {
    super("Correct Segment");
  }

  /** Forgets the strokes of a session that has ended. */
  static synchronized void forget() {
    DONE.clear();
    UNDONE.clear();
  }

  @Override
  void execute() throws StackRefused {
    StackSession session = Sessions.current();
    GenericDialog dialog = new GenericDialog("Correct Segment");
    String[] actions = {ADD, REMOVE, UNDO, REDO};
    dialog.addChoice("Action", actions, ADD);
    dialog.addNumericField("Radius", Prefs.get("palpate.brush", 2), 2, 8, "mm");
    dialog.showDialog();
    if (dialog.wasCanceled()) {
      return;
    }
    String action = dialog.getNextChoice();
    double radiusMm = dialog.getNextNumber();
    if (dialog.invalidNumber() || !(radiusMm > 0)) {
      throw new StackRefused("The radius must be a positive number of mm.");
    }
    Prefs.set("palpate.brush", radiusMm);
    carryOut(session, action, radiusMm);
    session.stackChanged();
  }

  private static synchronized void carryOut(StackSession session, String action, double radiusMm)
      throws StackRefused {
    switch (action) {
      case UNDO -> move(DONE, UNDONE, true);
      case REDO -> move(UNDONE, DONE, false);
      default -> paint(session, action.equals(ADD), radiusMm);
    }
  }

  private static void move(Deque<BrushStroke> from, Deque<BrushStroke> to, boolean undo)
      throws StackRefused {
    if (from.isEmpty()) {
      throw new StackRefused(undo ? "There is nothing to undo." : "There is nothing to redo.");
    }
    BrushStroke stroke = from.pop();
    if (undo) {
      stroke.undo();
    } else {
      stroke.redo();
    }
    to.push(stroke);
    IJ.showStatus("Palpate: " + stroke.size() + " voxels changed");
  }

  private static void paint(StackSession session, boolean add, double radiusMm)
      throws StackRefused {
    Vec3 tip = session.tipGrid();
    if (!tip.isFinite()) {
      throw new StackRefused("The first frame has not run yet: touch the volume first.");
    }
    VoxelRule rule = session.firstRule();
    float value = (float) (add ? rule.lower() : outside(rule));
    Vec3 spacing = session.geometry().grid().spacingMm();
    BrushStroke stroke = BrushStroke.paint(session.volume(), tip, spacing, radiusMm, value, rule);
    DONE.push(stroke);
    UNDONE.clear();
    if (DONE.size() > KEPT_STROKES) {
      DONE.removeLast();
    }
    IJ.showStatus("Palpate: " + stroke.size() + " voxels changed");
  }

  /** A value that does not belong to the segment: background where that does not. */
  private static double outside(VoxelRule rule) throws StackRefused {
    if (!rule.holds(0)) {
      return 0;
    }
    if (rule.upper() < 255) {
      return rule.upper() + 1;
    }
    throw new StackRefused(
        "The segment holds the value 0 too: there is no value to remove voxels with.");
  }
}
