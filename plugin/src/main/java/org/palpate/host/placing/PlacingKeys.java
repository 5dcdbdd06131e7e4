package org.palpate.host.placing;

import java.util.List;
import java.util.function.Consumer;
import org.palpate.body.BodyGroups;
import org.palpate.frame.ToolFrame;
import org.palpate.host.TouchSession;
import org.palpate.scene.window.WindowInput;

/**
 * The keys that lock bodies, that bind bodies so that they move as one, and that turn the body in
 * hand. Any thread.
 */
public final class PlacingKeys {
  private static final int NONE = -1;

  private final TouchSession session;
  private final ToolFrame frame;
  private final List<String> names;
  private final Consumer<String> hint;

  /** The body to which the next one is bound. */
  private int marked = NONE;

  /**
   * Creates the keys of a session.
   *
   * @param session a session whose bodies can be taken in hand
   * @param names the names of the bodies
   * @param hint shows a line to the user
   */
  public PlacingKeys(TouchSession session, List<String> names, Consumer<String> hint) {
    this.session = session;
    frame = session.toolFrame().orElseThrow();
    this.names = names;
    this.hint = hint;
  }

  /**
   * Adds the keys to a window.
   *
   * @param input the keys of the window
   */
  public void addTo(WindowInput input) {
    input.onKey('1', "attach the touched body to another; twice on one: detach it", this::bind);
    input.onKey('2', "lock the touched body, or unlock it", this::lock);
    new TurningKeys(session, hint).addTo(input);
  }

  /** Locks the body that is held or pressed, with all that are bound to it, or unlocks it. */
  synchronized void lock() {
    int body = chosen();
    if (body == NONE) {
      return;
    }
    BodyGroups groups = frame.groups();
    boolean locks = !groups.isLocked(body);
    frame.requestGroups(groups.withLock(body, locks));
    if (frame.heldBody() >= 0) {
      frame.requestLetGo();
    }
    hint.accept(name(body) + (locks ? " is locked" : " can be taken"));
  }

  /**
   * Marks the body that is held or pressed, or binds it to the one that is marked. The marked body
   * itself is detached.
   */
  synchronized void bind() {
    int body = chosen();
    if (body == NONE) {
      return;
    }
    BodyGroups groups = frame.groups();
    if (marked == NONE) {
      marked = body;
      hint.accept(name(body) + " is marked: touch another body and press 1, or 1 again to detach");
      return;
    }
    if (marked == body) {
      frame.requestGroups(groups.alone(body));
      hint.accept(name(body) + " moves alone");
    } else {
      frame.requestGroups(groups.bound(marked, body));
      hint.accept(name(marked) + " and " + name(body) + " move as one");
    }
    marked = NONE;
  }

  private int chosen() {
    int body = frame.chosenBody();
    if (body == NONE) {
      hint.accept("touch a body that can move first");
    }
    return body;
  }

  private String name(int body) {
    int others = frame.groups().size(body) - 1;
    return names.get(body) + (others > 0 ? " and " + others + " more" : "");
  }
}
