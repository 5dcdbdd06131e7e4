package org.palpate.loop;

import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import javax.management.InstanceNotFoundException;
import javax.management.JMException;
import javax.management.MBeanServer;
import javax.management.ObjectName;
import javax.management.ReflectionException;

/**
 * Tells whether the JVM's second compiler, which makes the fast code, still has work.
 *
 * <p>HotSpot lists the methods that it compiles and those that wait. Its second compiler is C2, or
 * Graal behind the name JVMCI. A JVM without such a list says how long it has compiled; its
 * compiler counts as busy if that has grown since the last question. One thread uses an instance.
 * The first question starts the JVM's management, which may take half a second.
 */
final class SecondCompiler implements BooleanSupplier {
  private static final String COMMANDS = "com.sun.management:type=DiagnosticCommand";
  private static final String LIST = "compilerQueue";

  /** A thread of this compiler, which the list prints before the method at work. */
  private static final String AT_WORK = "(C2|JVMCI|JVMCI-native) CompilerThread";

  private static final String WAITING = "(C2|JVMCI) compile queue:\\s*+(?!Empty)";
  private static final Pattern BUSY = Pattern.compile(AT_WORK + "|" + WAITING);

  private final Supplier<MBeanServer> management;
  private long millisBefore;

  /** Creates one that asks this JVM. */
  SecondCompiler() {
    this(ManagementFactory::getPlatformMBeanServer);
  }

  /** Creates one that asks for lists elsewhere; the first question needs the server. */
  SecondCompiler(Supplier<MBeanServer> management) {
    this.management = management;
  }

  /**
   * Returns whether the compiler has work.
   *
   * @throws IllegalStateException if the JVM has a list and cannot give it
   */
  @Override
  public boolean getAsBoolean() {
    try {
      String list = (String) management.get().invoke(new ObjectName(COMMANDS), LIST, null, null);
      return isBusy(list);
    } catch (InstanceNotFoundException e) {
      return hasCompiledMore(); // This JVM has no diagnostic commands.
    } catch (ReflectionException e) {
      if (e.getCause() instanceof NoSuchMethodException) {
        return hasCompiledMore(); // Its diagnostic commands include no such list.
      }
      throw unreadable(e);
    } catch (JMException e) {
      throw unreadable(e);
    }
  }

  private static IllegalStateException unreadable(JMException cause) {
    return new IllegalStateException("the JVM does not list the methods to compile", cause);
  }

  /** Returns whether a list names a method that the second compiler compiles or shall compile. */
  static boolean isBusy(String list) {
    return BUSY.matcher(list).find();
  }

  private boolean hasCompiledMore() {
    CompilationMXBean compiler = ManagementFactory.getCompilationMXBean();
    if (compiler == null || !compiler.isCompilationTimeMonitoringSupported()) {
      return false;
    }
    long before = millisBefore;
    millisBefore = compiler.getTotalCompilationTime();
    return millisBefore > before;
  }
}
