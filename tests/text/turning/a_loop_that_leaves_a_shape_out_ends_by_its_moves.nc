(run with: --machine lathe2)
O1 (turning, cycles along a shape: a shape that does not end is an alarm)
G97 S500 M03
G00 X64. Z2.
G71 U3. R.5
G71 P10 Q50 U.4 W.1 F.3
N10 G00 X20.
N20 G01 W-.001 F.15 (expect alarm PS0063 says does not come to its last block)
GOTO 20
N50 X64.
M30
