package org.palpate.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.UnaryOperator;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.SceneState.DrawnObject;
import org.palpate.scene.SceneState.LegendEntry;
import org.palpate.scene.SceneState.Look;

/**
 * Everything that is drawn. Any thread changes it under one short lock; the renderer takes a {@link
 * #state}.
 *
 * <p>A change requests one redraw. A change of look, visibility, colour, opacity or text to the
 * same value requests none.
 */
public final class SceneModel {
  /** A clipping plane follows the interaction point by steps of this fraction of the radius. */
  private static final double CLIP_STEP = 0.005;

  /** One counter for all models, so that a renderer never confuses two models. */
  private static final AtomicLong REVISIONS = new AtomicLong();

  /** The opacity of a ghost: a faint copy of a segment, or a segment that nothing touches. */
  static final double GHOST_OPACITY = 0.25;

  private final WorldAxes axes;
  private final List<SceneObject> objects = new ArrayList<>();
  private final List<Runnable> redrawRequests = new CopyOnWriteArrayList<>();
  private Camera camera = Camera.seeing(new Vec3(), List.of(), StandardView.OBLIQUE, 1);
  private Optional<TouchMarks> marks = Optional.empty();
  private Optional<Deformation> deformation = Optional.empty();
  private List<String> overlay = List.of();
  private List<String> help = List.of();
  private List<NamedPoint> landmarks = List.of();
  private Optional<Integer> legendSelection = Optional.empty();
  private boolean upsideDown;
  private ClipPlane.Direction clip = ClipPlane.Direction.OFF;
  private Optional<Vec3> clipPoint = Optional.empty();
  private OptionalDouble clipWorldMm = OptionalDouble.empty();
  private Look look;
  private long staticRevision;
  private boolean moving;
  private final Vec3 middle = new Vec3();
  private double radiusMm = 1;
  private double detailMm;

  /** Creates an empty scene in a world with the given axes. */
  public SceneModel(WorldAxes axes, Theme theme) {
    this.axes = axes;
    look = new Look(theme, axes, Stereo.OFF, Optional.empty(), Optional.empty());
  }

  /** Returns the orientation of the world's axes. */
  public WorldAxes axes() {
    return axes;
  }

  /**
   * Adds a listener that redraws. It is called outside the lock on the thread that changed the
   * model.
   */
  public void onChange(Runnable redraw) {
    redrawRequests.add(redraw);
  }

  /**
   * Adds a segment without a surface.
   *
   * @param rgb colour, 0xRRGGBB
   * @param gridMmToWorld pose in the world
   * @param lowMm low corner of the box of its solid voxels, grid mm
   * @param highMm high corner of that box
   */
  public SceneObject add(
      String name, int rgb, RigidTransform gridMmToWorld, Vec3 lowMm, Vec3 highMm) {
    SceneObject object = new SceneObject(name, rgb, axes.toScene(gridMmToWorld), lowMm, highMm);
    synchronized (this) {
      objects.add(object);
      fitBoundingBall();
      staticRevision = REVISIONS.incrementAndGet();
    }
    requestRedraw();
    return object;
  }

  /**
   * Records the longest voxel edge of a segment, the largest distance between drawn and touched
   * surface.
   */
  synchronized void addDetail(double longestEdgeMm) {
    detailMm = Math.max(detailMm, longestEdgeMm);
  }

  /** Returns the segments in the order in which they were added. */
  public synchronized List<SceneObject> objects() {
    return List.copyOf(objects);
  }

  /** Returns the camera as it is now. */
  public synchronized Camera camera() {
    return camera;
  }

  /** Moves the camera so that it sees everything from one side. */
  public void look(StandardView view, double aspect) {
    synchronized (this) {
      Camera seeing = Camera.seeing(middle, corners(), view, aspect);
      camera = upsideDown ? seeing.upsideDown() : seeing;
      staticRevision = REVISIONS.incrementAndGet();
    }
    requestRedraw();
  }

  /** Turns the pictures of {@link #look} by half a turn, for files whose axes are upside down. */
  public synchronized void setUpsideDown(boolean turned) {
    upsideDown = turned;
  }

  /**
   * Moves the camera.
   *
   * @param stillMoving whether more moves follow, so that speed matters more than detail
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

  /** Sets the colour of a segment, 0xRRGGBB. */
  public void setColour(SceneObject object, int rgb) {
    change(
        () -> {
          boolean differs = object.rgb != rgb;
          object.rgb = rgb;
          return differs;
        },
        true);
  }

  /** Makes a segment a ghost: it is drawn faintly, and the mouse does not meet it. */
  void makeGhost(SceneObject object) {
    change(
        () -> {
          object.opacity = GHOST_OPACITY;
          object.isGhost = true;
          return true;
        },
        true);
  }

  /** Sets the opacity of a segment: 1 is opaque, 0 hides it. */
  public void setOpacity(SceneObject object, double opacity) {
    change(
        () -> {
          boolean differs = object.opacity != opacity;
          object.opacity = opacity;
          return differs;
        },
        true);
  }

  /** Grows the box of a segment to its whole grid, because its voxels changed. */
  synchronized void includeGrid(SceneObject object, Vec3 sizesMm) {
    object.includeGrid(sizesMm);
    fitBoundingBall();
  }

  /** Whether a segment is shown. */
  synchronized boolean isVisible(SceneObject object) {
    return object.visible;
  }

  /** Returns the colour of a segment, 0xRRGGBB. */
  synchronized int colour(SceneObject object) {
    return object.rgb;
  }

  /** Shows the legend with one segment selected. */
  void setLegend(int selected) {
    change(
        () -> {
          boolean differs = !legendSelection.equals(Optional.of(selected));
          legendSelection = Optional.of(selected);
          return differs;
        },
        false);
  }

  private List<LegendEntry> legend() {
    List<LegendEntry> entries = new ArrayList<>();
    for (SceneObject object : legendSelection.isPresent() ? objects : List.<SceneObject>of()) {
      boolean selected = entries.size() == legendSelection.get();
      entries.add(new LegendEntry(object.name(), object.rgb, object.visible, selected));
    }
    return entries;
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

  /** Draws a faint copy of a segment at another pose, or draws it no more. */
  public void setGhost(SceneObject object, Optional<RigidTransform> gridMmToWorld) {
    change(
        () -> {
          object.ghost = gridMmToWorld.map(axes::toScene).orElse(null);
          return true;
        },
        true);
  }

  /** Colours a part of a surface by a measured value, or no more. */
  public void setTint(SceneObject object, Optional<SurfaceTint> tint) {
    change(
        () -> {
          boolean differs = !Optional.ofNullable(object.tint).equals(tint);
          object.tint = tint.orElse(null);
          return differs;
        },
        true);
  }

  /** Reports that surface bricks were added or removed. */
  void surfaceChanged() {
    change(() -> true, true);
  }

  /** Shows the device, interaction point and force, or hides them. */
  public void setMarks(Optional<TouchMarks> shown) {
    Optional<Deformation> present;
    synchronized (this) {
      present = deformation;
    }
    setMarks(shown, present);
  }

  /**
   * Shows the marks of a frame together with the deformation under its force.
   *
   * @param deformed what {@link Deformation} says; the same object again if it did not change
   */
  public void setMarks(Optional<TouchMarks> shown, Optional<Deformation> deformed) {
    boolean clips;
    boolean deforms;
    synchronized (this) {
      clips = clip != ClipPlane.Direction.OFF && shown.isPresent() && isFarFromClip(shown.get());
      deforms = !deformed.equals(deformation);
    }
    change(
        () -> {
          marks = shown;
          deformation = deformed;
          clipPoint = clips ? Optional.of(shown.get().point()) : clipPoint;
          return true;
        },
        clips || deforms);
  }

  private boolean isFarFromClip(TouchMarks shown) {
    return clipPoint.isEmpty()
        || clipPoint.get().sub(shown.point(), new Vec3()).length() > CLIP_STEP * radiusMm;
  }

  /** Hides the surfaces in front of a plane. */
  public void clip(ClipPlane.Start start) {
    clipWith(
        () -> {
          clip = start.direction();
          clipWorldMm = start.worldMm();
        });
  }

  /**
   * Turns the clipping plane to its next direction, or takes it away after the last one. It leads
   * through the interaction point, or through the middle of all objects before there is one.
   */
  public void clipNext() {
    clipWith(
        () -> {
          clip = clip.next();
          clipWorldMm = OptionalDouble.empty();
        });
  }

  private void clipWith(Runnable turn) {
    change(
        () -> {
          turn.run();
          clipPoint = marks.map(TouchMarks::point);
          return true;
        },
        true);
  }

  /** Returns a point of the clipping plane. */
  private Vec3 clipPoint() {
    Vec3 point = new Vec3().set(clipPoint.orElse(middle));
    if (clipWorldMm.isPresent()) {
      Vec3 world = axes.toSceneOrBack(point, new Vec3());
      world.set(clip.axis(), clipWorldMm.getAsDouble());
      axes.toSceneOrBack(world, point);
    }
    return point;
  }

  /** Shows these landmarks and no others; positions in world mm. */
  public void setLandmarks(List<NamedPoint> world) {
    List<NamedPoint> shown =
        world.stream()
            .map(
                mark ->
                    new NamedPoint(mark.name(), axes.toSceneOrBack(mark.position(), new Vec3())))
            .toList();
    change(
        () -> {
          landmarks = shown;
          return true;
        },
        false);
  }

  /** Sets the lines of text in the upper left corner. */
  void setOverlay(List<String> lines) {
    change(
        () -> {
          boolean differs = !lines.equals(overlay);
          overlay = List.copyOf(lines);
          return differs;
        },
        false);
  }

  /** Sets the lines of text in the middle; none hides them. */
  public void setHelp(List<String> lines) {
    change(
        () -> {
          boolean differs = !lines.equals(help);
          help = List.copyOf(lines);
          return differs;
        },
        false);
  }

  /** Returns a copy of what is to be drawn. */
  public synchronized SceneState state() {
    List<DrawnObject> drawn = new ArrayList<>();
    for (SceneObject object : objects) {
      if (object.visible && object.opacity > 0) {
        Optional<SurfaceTint> tint = Optional.ofNullable(object.tint);
        drawn.add(
            new DrawnObject(object, object.rgb, object.opacity, object.pose, tint, object.isGhost));
        if (object.ghost != null) {
          drawn.add(
              new DrawnObject(
                  object, object.rgb, GHOST_OPACITY, object.ghost, Optional.empty(), true));
        }
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
        landmarks,
        legend(),
        clip.through(clipPoint(), camera),
        deformation);
  }

  private interface Change {
    /** Applies the change; returns whether it made a difference. */
    boolean apply();
  }

  private void change(Change change, boolean isStatic) {
    boolean differs;
    synchronized (this) {
      differs = change.apply();
      if (differs && isStatic) {
        staticRevision = REVISIONS.incrementAndGet();
      }
    }
    if (differs) {
      requestRedraw();
    }
  }

  /** Requests a picture although nothing changed, for example after a window was uncovered. */
  public void requestRedraw() {
    redrawRequests.forEach(Runnable::run);
  }

  /** Updates the ball around the boxes of all objects. */
  private void fitBoundingBall() {
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
