/**
 * Keeps the connection to the X server: holds one open, and keeps the process alive when the server
 * goes away.
 *
 * <p>Uses JNA alone. The graphics driver is loaded with a connection held. The command line
 * installs the handler of a loss before it opens a window; the handler runs in the thread that met
 * the broken connection.
 */
package org.palpate.display;
