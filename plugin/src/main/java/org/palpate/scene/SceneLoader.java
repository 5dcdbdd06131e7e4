package org.palpate.scene;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeoutException;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.surface.AmbientOcclusion;
import org.palpate.scene.surface.CoarseVolume;
import org.palpate.scene.surface.DensityAmbientOcclusion;
import org.palpate.scene.surface.GreyRange;
import org.palpate.scene.surface.SurfaceBuilder;
import org.palpate.scene.surface.SurfaceJob;
import org.palpate.scene.surface.SurfaceSource;
import org.palpate.scene.surface.WeldedSurface;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * Builds the surfaces of a volume's segments in the background: first at a quarter of the
 * resolution, then at half, then at full.
 *
 * <p>In a window the finer levels wait until the coarsest one was drawn ({@link #forWindow}), so
 * that building them does not delay it. Any thread; whoever creates the loader closes it.
 */
public final class SceneLoader implements AutoCloseable {
  private static final int COARSEST_LEVEL = SceneObject.LEVELS - 1;

  private static final double ENCLOSING_OPACITY = 0.3;

  private final SceneModel model;
  private final SurfaceBuilder builder;
  private final SegmentedVolume volume;

  /** Whether the segments stand at poses, so that those at rest do not darken each other. */
  private final boolean isPlaced;

  private volatile List<AmbientOcclusion> occlusions;
  private final List<BitCube> cubes = new ArrayList<>();
  private final List<Optional<GreyRange>> greys;
  private final List<SceneObject> objects = new ArrayList<>();
  private final List<SurfaceSource> sources = new ArrayList<>();

  /** The coarse copies of each segment, at half and at a quarter of the resolution. */
  private final List<List<CoarseVolume>> coarse = new ArrayList<>();

  private final List<SurfaceJob> jobs = new CopyOnWriteArrayList<>();

  private final int threads;

  /** Builds the surfaces of ghosts, if there are any. */
  private volatile Optional<SceneLoader> ghosts = Optional.empty();

  /** Whether the finer levels were started, or never will be. */
  private volatile boolean refined;

  /** Adds the segments of a volume to a model and starts building their surfaces from bits. */
  public SceneLoader(SceneModel model, SegmentedVolume volume, int threads) {
    this(model, volume, List.of(), threads);
  }

  /**
   * Adds the segments of a volume to a model and starts building their surfaces.
   *
   * @param greys grey values for each segment whose finest surface follows them, in the order of
   *     the segments; missing ones at the end use the bits
   */
  public SceneLoader(
      SceneModel model, SegmentedVolume volume, List<Optional<GreyRange>> greys, int threads) {
    this(model, volume, greys, List.of(), threads, false);
  }

  /**
   * Adds segments to a model where their placements put them, and starts building their surfaces
   * from bits.
   *
   * @param poses the pose of each segment, from rest to present, world mm; none if all stand at
   *     rest
   */
  public static SceneLoader ofPlaced(
      SceneModel model, SegmentedVolume volume, List<RigidTransform> poses, int threads) {
    return new SceneLoader(model, volume, List.of(), poses, threads, false);
  }

  private SceneLoader(
      SceneModel model,
      SegmentedVolume volume,
      List<Optional<GreyRange>> greys,
      List<RigidTransform> poses,
      int threads,
      boolean waitsForPicture) {
    this.model = model;
    this.greys = List.copyOf(greys);
    this.volume = volume;
    this.threads = threads;
    isPlaced = !poses.isEmpty();
    builder = new SurfaceBuilder(threads);
    List<Segment> segments = volume.segments();
    segments.forEach(segment -> cubes.add(segment.bits()));
    occlusions = newOcclusions();
    addDetail(volume.grid());
    for (int n = 0; n < segments.size(); n++) {
      addDetail(volume.grid(n));
      add(
          segments.get(n),
          isPlaced ? gridMmToWorld(n, poses.get(n)) : volume.grid(n).gridMmToWorld());
    }
    if (!isPlaced) {
      makeEnclosingTranslucent();
    }
    start(COARSEST_LEVEL);
    if (!waitsForPicture) {
      refine();
    }
  }

  /**
   * Returns a loader for a window: it starts the finer levels in {@link #pictureDrawn}, once the
   * coarsest level is complete.
   *
   * @param poses the pose of each segment, from rest to present, world mm; none if all stand at
   *     rest
   */
  public static SceneLoader forWindow(
      SceneModel model,
      SegmentedVolume volume,
      List<Optional<GreyRange>> greys,
      List<RigidTransform> poses,
      int threads) {
    return new SceneLoader(model, volume, greys, poses, threads, true);
  }

  /**
   * Adds ghosts, once: segments that are drawn faintly, each where its grid puts it. They are no
   * segments of this loader, so they have no number and no welded surface. Their finer levels wait
   * as those of this loader do. Before any other thread uses this loader.
   *
   * @param shown the ghosts
   */
  public void addGhosts(SegmentedVolume shown) {
    List<RigidTransform> atRest =
        Collections.nCopies(shown.segments().size(), RigidTransform.identity());
    SceneLoader faint = new SceneLoader(model, shown, List.of(), atRest, threads, !refined);
    faint.objects.forEach(model::makeGhost);
    ghosts = Optional.of(faint);
  }

  private void addDetail(VoxelGrid grid) {
    Vec3 spacing = grid.spacingMm();
    model.addDetail(Math.max(spacing.x, Math.max(spacing.y, spacing.z)));
  }

  private RigidTransform gridMmToWorld(int segment, RigidTransform restToPresent) {
    return restToPresent.multiply(volume.grid(segment).gridMmToWorld());
  }

  /**
   * Moves a segment as a whole; its surface is not built again.
   *
   * @param segment number of the segment
   * @param restToPresent its pose, world mm
   */
  public void move(int segment, RigidTransform restToPresent) {
    model.setPose(objects.get(segment), gridMmToWorld(segment, restToPresent));
  }

  /**
   * Shows a faint copy of a segment at another pose, or hides it.
   *
   * @param segment number of the segment
   * @param restToPresent the pose of the copy, world mm
   */
  public void showGhost(int segment, Optional<RigidTransform> restToPresent) {
    model.setGhost(objects.get(segment), restToPresent.map(pose -> gridMmToWorld(segment, pose)));
  }

  /** Colours a part of a segment's surface by a measured value, or no more. */
  public void tint(int segment, Optional<SurfaceTint> tint) {
    model.setTint(objects.get(segment), tint);
  }

  /**
   * Reports that a picture of the model was drawn. Any thread, at every picture; it only reads a
   * flag once the finer levels are started.
   */
  public void pictureDrawn() {
    if (!refined && isCoarseDone()) {
      refine();
    }
    ghosts.ifPresent(SceneLoader::pictureDrawn);
  }

  /**
   * Whether the coarsest level is complete. It is asked after the picture that the last coarse
   * surface caused.
   */
  private boolean isCoarseDone() {
    for (int i = 0; i < objects.size(); i++) {
      // A failed level is never complete, but the finer levels may still succeed.
      if (!objects.get(i).isComplete(COARSEST_LEVEL) && !jobs.get(i).isDone()) {
        return false;
      }
    }
    return true;
  }

  private synchronized void refine() {
    if (!refined) {
      refined = true;
      for (int level = COARSEST_LEVEL - 1; level >= 0; level--) {
        start(level);
      }
    }
  }

  private void start(int level) {
    for (int i = 0; i < objects.size(); i++) {
      jobs.add(build(i, level));
    }
  }

  private void add(Segment segment, RigidTransform pose) {
    int number = sources.size();
    VoxelGrid grid = volume.grid(number);
    IntBox box = segment.bits().bounds();
    Vec3 spacing = grid.spacingMm();
    Vec3 low = new Vec3();
    Vec3 high = new Vec3(grid.sizeX(), grid.sizeY(), grid.sizeZ());
    if (!box.isEmpty()) {
      low.set(box.lowX, box.lowY, box.lowZ);
      high.set(box.highX + 1, box.highY + 1, box.highZ + 1);
    }
    low.set(low.x * spacing.x, low.y * spacing.y, low.z * spacing.z);
    high.set(high.x * spacing.x, high.y * spacing.y, high.z * spacing.z);
    objects.add(model.add(segment.name(), segment.rgb(), pose, low, high));
    coarse.add(List.of(CoarseVolume.of(segment.bits(), 1), CoarseVolume.of(segment.bits(), 2)));
    Optional<GreyRange> grey = number < greys.size() ? greys.get(number) : Optional.empty();
    sources.add(
        grey.map(values -> SurfaceSource.ofGrey(segment.bits(), values, spacing))
            .orElseGet(() -> SurfaceSource.ofBits(segment.bits(), spacing)));
  }

  /** Makes a segment that encloses all others, such as skin, translucent. */
  private void makeEnclosingTranslucent() {
    for (SceneObject object : objects) {
      if (objects.size() > 1 && objects.stream().allMatch(object::encloses)) {
        model.setOpacity(object, ENCLOSING_OPACITY);
      }
    }
  }

  /** Starts building all bricks of a level. */
  private SurfaceJob build(int number, int level) {
    SceneObject object = objects.get(number);
    SurfaceSource source = source(number, level);
    SurfaceBuilder.Kind kind = level == 0 ? SurfaceBuilder.Kind.FINE : SurfaceBuilder.Kind.COARSE;
    return builder.build(
        source,
        occlusionAt(number, level),
        kind,
        object.store(level, source.bits()),
        () -> markComplete(object, level));
  }

  private SurfaceSource source(int number, int level) {
    SurfaceSource fine = sources.get(number);
    return level == 0 ? fine : coarse(number, level).source(fine.spacingMm());
  }

  private CoarseVolume coarse(int number, int level) {
    return coarse.get(number).get(level - 1);
  }

  private AmbientOcclusion occlusionAt(int segment, int level) {
    AmbientOcclusion fine = occlusions.get(segment);
    return level == 0 ? fine : scaled(fine, 1 << level);
  }

  private static AmbientOcclusion scaled(AmbientOcclusion fine, int factor) {
    return (x, y, z, nx, ny, nz) -> fine.at(x * factor, y * factor, z * factor, nx, ny, nz);
  }

  private void markComplete(SceneObject object, int level) {
    object.setComplete(level);
    model.surfaceChanged();
  }

  /**
   * Returns the fraction of the surfaces that is complete, 0 to 1; each level of each segment
   * counts alike, and ghosts do not count.
   */
  public double progress() {
    int all = objects.size() * (COARSEST_LEVEL + 1);
    return all == 0 ? 1 : jobs.stream().mapToDouble(SurfaceJob::progress).sum() / all;
  }

  /**
   * Waits for every surface that was started, those of ghosts too.
   *
   * @throws TimeoutException if it takes longer
   */
  public void await(long timeoutMillis) throws InterruptedException, TimeoutException {
    for (SurfaceJob job : jobs) {
      job.await(timeoutMillis);
    }
    if (ghosts.isPresent()) {
      ghosts.get().await(timeoutMillis);
    }
  }

  /**
   * Rebuilds the surface where an edit changed voxels. The finest level comes before the coarser
   * ones, and both take turns with bricks that are built for the first time. A level whose building
   * has not started needs nothing. The bits must have been changed and published before.
   *
   * @param segment number of the segment
   * @param voxels a box around the edited voxels
   * @return the job of each level whose building has started, the finest first
   */
  public synchronized List<SurfaceJob> remesh(int segment, IntBox voxels) {
    List<SurfaceJob> started = new ArrayList<>();
    if (refined) {
      started.add(rebuild(segment, 0, voxels, SurfaceBuilder.Kind.EDITED));
    }
    for (int level = 1; level < SceneObject.LEVELS; level++) {
      CoarseVolume copy = coarse(segment, level);
      copy.update(voxels);
      if (refined || level == COARSEST_LEVEL) {
        IntBox box = copy.toCoarse(voxels, new IntBox());
        started.add(rebuild(segment, level, box, SurfaceBuilder.Kind.EDITED_COARSE));
      }
    }
    return started;
  }

  /** Returns the ambient occlusion of each segment. */
  private List<AmbientOcclusion> newOcclusions() {
    if (isPlaced || cubes.isEmpty()) {
      return cubes.stream()
          .<AmbientOcclusion>map(cube -> new DensityAmbientOcclusion(List.of(cube)))
          .toList();
    }
    return Collections.nCopies(cubes.size(), new DensityAmbientOcclusion(List.copyOf(cubes)));
  }

  /**
   * Replaces the voxels of a segment and rebuilds its surface, the coarsest level first.
   *
   * @param segment number of the segment
   * @param bits its new voxels
   * @param grey the grey values that its finest surface follows; if empty, it follows the voxels
   */
  public synchronized void replace(int segment, BitCube bits, Optional<GreyRange> grey) {
    VoxelGrid grid = volume.grid(segment);
    Vec3 spacing = grid.spacingMm();
    cubes.set(segment, bits);
    occlusions = newOcclusions();
    coarse.set(segment, List.of(CoarseVolume.of(bits, 1), CoarseVolume.of(bits, 2)));
    sources.set(
        segment,
        grey.map(values -> SurfaceSource.ofGrey(bits, values, spacing))
            .orElseGet(() -> SurfaceSource.ofBits(bits, spacing)));
    model.includeGrid(
        objects.get(segment),
        new Vec3(grid.sizeX() * spacing.x, grid.sizeY() * spacing.y, grid.sizeZ() * spacing.z));
    for (int level = COARSEST_LEVEL; level >= 0; level--) {
      build(segment, level);
    }
  }

  private SurfaceJob rebuild(int segment, int level, IntBox voxels, SurfaceBuilder.Kind kind) {
    SurfaceSource source = source(segment, level);
    SceneObject object = objects.get(segment);
    return builder.rebuild(
        source,
        occlusionAt(segment, level),
        kind,
        voxels,
        object.store(level, source.bits()),
        model::surfaceChanged);
  }

  /** Returns the finest surface of each segment; complete only after {@link #await}. */
  public List<WeldedSurface> weldedSurfaces() {
    return objects.stream().map(object -> WeldedSurface.of(object.bricks(0).values())).toList();
  }

  /** Stops building; finished surfaces stay. */
  @Override
  public synchronized void close() {
    refined = true; // levels that were not started are never started
    builder.close();
    ghosts.ifPresent(SceneLoader::close);
  }
}
