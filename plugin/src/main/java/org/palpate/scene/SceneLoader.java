package org.palpate.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeoutException;
import java.util.stream.IntStream;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.surface.AmbientOcclusion;
import org.palpate.scene.surface.BrickLayout;
import org.palpate.scene.surface.CoarseVolume;
import org.palpate.scene.surface.DensityAmbientOcclusion;
import org.palpate.scene.surface.GreyRange;
import org.palpate.scene.surface.SurfaceBuilder;
import org.palpate.scene.surface.SurfaceExtractor;
import org.palpate.scene.surface.SurfaceJob;
import org.palpate.scene.surface.SurfaceSource;
import org.palpate.scene.surface.WeldedSurface;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * Gives the segments of a volume their surfaces, in the background: a quarter of the resolution
 * first, then a half, then all. Any thread; closed by whoever opened it.
 *
 * <p>In a window the finer levels wait until the coarse one was seen ({@link #forWindow}), so that
 * their making does not keep the processors from showing it.
 */
public final class SceneLoader implements AutoCloseable {
  private static final int COARSEST = SceneObject.LEVELS - 1;

  private static final double SURROUNDING_OPACITY = 0.3;

  private final SceneModel model;
  private final SurfaceBuilder builder;
  private final VoxelGrid grid;
  private final AmbientOcclusion openness;
  private final List<Optional<GreyRange>> greys;
  private final List<SceneObject> objects = new ArrayList<>();
  private final List<SurfaceSource> sources = new ArrayList<>();

  /** Of each segment at a half and at a quarter of the resolution. */
  private final List<List<CoarseVolume>> coarse = new ArrayList<>();

  private final List<SurfaceJob> builds = new CopyOnWriteArrayList<>();

  /** Whether the finer levels were begun, or never will be. */
  private volatile boolean refined;

  /** Adds the segments of a volume to a model and begins with their surfaces, made of bits. */
  public SceneLoader(SceneModel model, SegmentedVolume volume, int threads) {
    this(model, volume, List.of(), threads);
  }

  /**
   * The same with finest surfaces that go by grey values.
   *
   * @param greys what each segment was made of, in their order; those that are missing at the end
   *     or empty go by their bits
   */
  public SceneLoader(
      SceneModel model, SegmentedVolume volume, List<Optional<GreyRange>> greys, int threads) {
    this(model, volume, greys, threads, false);
  }

  private SceneLoader(
      SceneModel model,
      SegmentedVolume volume,
      List<Optional<GreyRange>> greys,
      int threads,
      boolean waits) {
    this.model = model;
    this.greys = List.copyOf(greys);
    grid = volume.grid();
    builder = new SurfaceBuilder(threads);
    List<Segment> segments = volume.segments();
    openness =
        segments.isEmpty()
            ? AmbientOcclusion.EVERYWHERE
            : new DensityAmbientOcclusion(segments.stream().map(Segment::bits).toList());
    Vec3 spacing = grid.spacingMm();
    model.addDetail(Math.max(spacing.x, Math.max(spacing.y, spacing.z)));
    segments.forEach(this::add);
    showWhatIsInside();
    begin(COARSEST);
    if (!waits) {
      refine();
    }
  }

  /**
   * The same for a window: the finer levels are begun by {@link #pictureDrawn}, once the coarsest
   * one is whole.
   */
  public static SceneLoader forWindow(
      SceneModel model, SegmentedVolume volume, List<Optional<GreyRange>> greys, int threads) {
    return new SceneLoader(model, volume, greys, threads, true);
  }

  /**
   * Says that a picture of the model was drawn. Any thread, as often as one likes; costs a look at
   * a flag once the finer levels are begun.
   */
  public void pictureDrawn() {
    if (!refined && isCoarseDone()) {
      refine();
    }
  }

  /** Asked after a picture that the last coarse surface called for, which is complete by then. */
  private boolean isCoarseDone() {
    for (int i = 0; i < objects.size(); i++) {
      // One that failed is never complete; the finer ones may yet be made.
      if (!objects.get(i).isComplete(COARSEST) && !builds.get(i).isDone()) {
        return false;
      }
    }
    return true;
  }

  private synchronized void refine() {
    if (!refined) {
      refined = true;
      for (int level = COARSEST - 1; level >= 0; level--) {
        begin(level);
      }
    }
  }

  private void begin(int level) {
    for (int i = 0; i < objects.size(); i++) {
      builds.add(build(i, level));
    }
  }

  private void add(Segment segment) {
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
    RigidTransform pose = grid.gridMmToWorld();
    objects.add(model.add(segment.name(), segment.rgb(), pose, low, high));
    coarse.add(List.of(CoarseVolume.of(segment.bits(), 1), CoarseVolume.of(segment.bits(), 2)));
    int number = sources.size();
    Optional<GreyRange> grey = number < greys.size() ? greys.get(number) : Optional.empty();
    sources.add(
        grey.map(values -> SurfaceSource.ofGrey(segment.bits(), values, spacing))
            .orElseGet(() -> SurfaceSource.ofBits(segment.bits(), spacing)));
  }

  /** Draws a segment that surrounds all others, such as skin, translucent. */
  private void showWhatIsInside() {
    for (SceneObject object : objects) {
      if (objects.size() > 1 && objects.stream().allMatch(object::surrounds)) {
        model.setOpacity(object, SURROUNDING_OPACITY);
      }
    }
  }

  /** Begins with all bricks of a level. */
  private SurfaceJob build(int number, int level) {
    SceneObject object = objects.get(number);
    int urgency = level == 0 ? SurfaceBuilder.FINE : SurfaceBuilder.COARSE;
    return builder.build(
        source(number, level),
        light(level),
        urgency,
        (brick, begun, mesh) -> object.put(level, brick, begun, mesh),
        () -> complete(object, level));
  }

  private SurfaceSource source(int number, int level) {
    SurfaceSource fine = sources.get(number);
    return level == 0 ? fine : coarse(number, level).source(fine.spacingMm());
  }

  private CoarseVolume coarse(int number, int level) {
    return coarse.get(number).get(level - 1);
  }

  private AmbientOcclusion light(int level) {
    return level == 0 ? openness : scaled(1 << level);
  }

  private AmbientOcclusion scaled(int factor) {
    return (x, y, z, nx, ny, nz) -> openness.at(x * factor, y * factor, z * factor, nx, ny, nz);
  }

  private void complete(SceneObject object, int level) {
    object.setComplete(level);
    model.surfaceChanged();
  }

  /** The share of the surfaces that is made, 0 to 1, each level of each segment alike. */
  public double progress() {
    int all = objects.size() * (COARSEST + 1);
    return all == 0 ? 1 : builds.stream().mapToDouble(SurfaceJob::progress).sum() / all;
  }

  /**
   * Waits for every surface that was begun.
   *
   * @throws TimeoutException where it takes longer
   */
  public void await(long timeoutMillis) throws InterruptedException, TimeoutException {
    for (SurfaceJob build : builds) {
      build.await(timeoutMillis);
    }
  }

  /**
   * Remeshes what an edit touched: the finest level before all other work, the coarser ones before
   * what is finest and was never seen. The bits must have been changed and published before.
   *
   * @param segment the number of the segment
   * @param voxels a box about the edited voxels
   * @return the work on each level, the finest first
   */
  public synchronized List<SurfaceJob> edited(int segment, IntBox voxels) {
    List<SurfaceJob> begun = new ArrayList<>();
    begun.add(rebuild(segment, 0, voxels, SurfaceBuilder.EDITED));
    for (int level = 1; level < SceneObject.LEVELS; level++) {
      CoarseVolume volume = coarse(segment, level);
      volume.update(voxels);
      IntBox box = volume.toCoarse(voxels, new IntBox());
      begun.add(rebuild(segment, level, box, SurfaceBuilder.COARSE));
    }
    return begun;
  }

  private SurfaceJob rebuild(int segment, int level, IntBox voxels, int urgency) {
    SurfaceSource source = source(segment, level);
    SceneObject object = objects.get(segment);
    return builder.build(
        source,
        light(level),
        urgency,
        touched(source, voxels),
        (brick, begun, mesh) -> object.put(level, brick, begun, mesh),
        model::surfaceChanged);
  }

  private static int[] touched(SurfaceSource source, IntBox voxels) {
    BrickLayout layout = BrickLayout.of(source.bits(), SurfaceExtractor.BRICK_EDGE);
    int reach = SurfaceExtractor.reach(source.smoothing());
    IntBox box = layout.touchedBy(voxels, reach, new IntBox());
    return IntStream.range(0, layout.count())
        .filter(brick -> box.contains(layout.x(brick), layout.y(brick), layout.z(brick)))
        .toArray();
  }

  /** The finest surfaces of all segments; whole only after {@link #await}. */
  public WeldedSurface weldedSurface() {
    return WeldedSurface.together(
        objects.stream().map(object -> WeldedSurface.of(object.bricks(0).values())).toList());
  }

  /** Stops the work; what is there stays. */
  @Override
  public synchronized void close() {
    refined = true; // what was not begun is not begun any more
    builder.close();
  }
}
