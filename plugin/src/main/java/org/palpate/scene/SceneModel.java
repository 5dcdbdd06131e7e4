package org.palpate.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.UnaryOperator;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.SceneState.DrawnObject;
import org.palpate.scene.SceneState.Look;

/**
 * Everything that can be seen. Any thread changes it, under one short lock; who draws takes a
 * {@link #state}. A change asks for one redraw; one of looks, visibility, colour, opacity or text
 * that makes no difference asks for none.
 */
public final class SceneModel {
  /** One count for all models, so that a renderer never takes one for the other. */
  private static final AtomicLong REVISIONS = new AtomicLong();

  private final WorldAxes axes;
  private final List<SceneObject> objects = new ArrayList<>();
  private final List<Runnable> redrawRequests = new CopyOnWriteArrayList<>();
  private Camera camera = Camera.seeing(new Vec3(), List.of(), StandardView.OBLIQUE, 1);
  private Optional<TouchMarks> marks = Optional.empty();
  private List<String> overlay = List.of();
  private List<String> help = List.of();
  private List<NamedPoint> landmarks = List.of();
  private Look look;
  private long staticRevision;
  private boolean moving;
  private final Vec3 middle = new Vec3();
  private double radiusMm = 1;
  private double detailMm;

  /** An empty scene in a world with the given axes. */
  public SceneModel(WorldAxes axes, Theme theme) {
    this.axes = axes;
    look = new Look(theme, axes, Stereo.OFF, Optional.empty());
  }

  public WorldAxes axes() {
    return axes;
  }

  /** Adds someone who redraws; called on the thread that changed something, outside the lock. */
  public void onChange(Runnable redraw) {
    redrawRequests.add(redraw);
  }

  /**
   * Adds a segment without a surface yet.
   *
   * @param rgb 0xRRGGBB
   * @param gridMmToWorld where it stands
   * @param lowMm low corner of the box about its solid voxels, grid mm
   * @param highMm its high corner
   */
  public SceneObject add(
      String name, int rgb, RigidTransform gridMmToWorld, Vec3 lowMm, Vec3 highMm) {
    SceneObject object = new SceneObject(name, rgb, axes.toScene(gridMmToWorld), lowMm, highMm);
    synchronized (this) {
      objects.add(object);
      fitBall();
      staticRevision = REVISIONS.incrementAndGet();
    }
    requestRedraw();
    return object;
  }

  /** Says how large a voxel of some segment is: so far may its surface be from what is touched. */
  public synchronized void addDetail(double longestEdgeMm) {
    detailMm = Math.max(detailMm, longestEdgeMm);
  }

  /** The segments in the order in which they were added. */
  public synchronized List<SceneObject> objects() {
    return List.copyOf(objects);
  }

  /** Looks at everything from one side. */
  public void look(StandardView view, double aspect) {
    synchronized (this) {
      camera = Camera.seeing(middle, corners(), view, aspect);
      staticRevision = REVISIONS.incrementAndGet();
    }
    requestRedraw();
  }

  /**
   * Moves the camera.
   *
   * @param stillMoving whether more moves are to come, so that speed counts more than detail
   */
  public void moveCamera(UnaryOperator<Camera> move, boolean stillMoving) {
    synchronized (this) {
      camera = move.apply(camera);
      moving = stillMoving;
      staticRevision = REVISIONS.incrementAndGet();
    }
    requestRedraw();
  }

  /** Changes theme, stereo or slices. */
  public void changeLook(UnaryOperator<Look> change) {
    change(
        () -> {
          Look changed = change.apply(look);
          boolean differs = !changed.equals(look);
          look = changed;
          return differs;
        },
        true);
  }

  /** Shows or hides a segment. */
  public void setVisible(SceneObject object, boolean visible) {
    change(
        () -> {
          boolean differs = object.visible != visible;
          object.visible = visible;
          return differs;
        },
        true);
  }

  /** Colours a segment: 0xRRGGBB. */
  public void setColour(SceneObject object, int rgb) {
    change(
        () -> {
          boolean differs = object.rgb != rgb;
          object.rgb = rgb;
          return differs;
        },
        true);
  }

  /** Makes a segment opaque, 1, or less so; 0 hides it. */
  public void setOpacity(SceneObject object, double opacity) {
    change(
        () -> {
          boolean differs = object.opacity != opacity;
          object.opacity = opacity;
          return differs;
        },
        true);
  }

  /** Moves a segment. */
  public void setPose(SceneObject object, RigidTransform gridMmToWorld) {
    change(
        () -> {
          object.pose = axes.toScene(gridMmToWorld);
          return true;
        },
        true);
  }

  /** Says that bricks of a segment came or went. */
  public void surfaceChanged() {
    change(() -> true, true);
  }

  /** Shows the hand, or no longer. */
  public void setMarks(Optional<TouchMarks> shown) {
    change(
        () -> {
          marks = shown;
          return true;
        },
        false);
  }

  /** Shows landmarks, all that there are; places in the world. */
  public void setLandmarks(List<NamedPoint> world) {
    List<NamedPoint> shown =
        world.stream()
            .map(mark -> new NamedPoint(mark.name(), axes.swap(mark.place(), new Vec3())))
            .toList();
    change(
        () -> {
          landmarks = shown;
          return true;
        },
        false);
  }

  /** Writes the lines in the corner. */
  public void setOverlay(List<String> lines) {
    change(
        () -> {
          boolean differs = !lines.equals(overlay);
          overlay = List.copyOf(lines);
          return differs;
        },
        false);
  }

  /** Writes the lines in the middle; none hides them. */
  public void setHelp(List<String> lines) {
    change(
        () -> {
          boolean differs = !lines.equals(help);
          help = List.copyOf(lines);
          return differs;
        },
        false);
  }

  /** A copy of what is to be drawn now. */
  public synchronized SceneState state() {
    List<DrawnObject> drawn = new ArrayList<>();
    for (SceneObject object : objects) {
      if (object.visible && object.opacity > 0) {
        drawn.add(new DrawnObject(object, object.rgb, object.opacity, object.pose));
      }
    }
    return new SceneState(
        drawn,
        camera,
        marks,
        overlay,
        help,
        new Vec3().set(middle),
        radiusMm,
        detailMm,
        look,
        staticRevision,
        moving,
        landmarks);
  }

  private interface Change {
    /** Whether it made a difference. */
    boolean apply();
  }

  private void change(Change change, boolean still) {
    boolean differs;
    synchronized (this) {
      differs = change.apply();
      if (differs && still) {
        staticRevision = REVISIONS.incrementAndGet();
      }
    }
    if (differs) {
      requestRedraw();
    }
  }

  /** Asks for a picture though nothing changed, as when a window was uncovered. */
  public void requestRedraw() {
    redrawRequests.forEach(Runnable::run);
  }

  /** The ball about the boxes of all objects. */
  private void fitBall() {
    Vec3 low = new Vec3(Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE);
    Vec3 high = new Vec3(-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE);
    for (Vec3 corner : corners()) {
      for (int axis = 0; axis < 3; axis++) {
        low.set(axis, Math.min(low.get(axis), corner.get(axis)));
        high.set(axis, Math.max(high.get(axis), corner.get(axis)));
      }
    }
    low.add(high, middle).mul(0.5, middle);
    radiusMm = high.sub(low, high).length() / 2;
  }

  private List<Vec3> corners() {
    List<Vec3> corners = new ArrayList<>();
    for (SceneObject object : objects) {
      for (int number = 0; number < 8; number++) {
        corners.add(object.pose.transform(object.corner(number), new Vec3()));
      }
    }
    return corners;
  }
}
