/** Tests of the command line's parts; whole commands are run in {@code tests}. */
package org.palpate.app.command;
