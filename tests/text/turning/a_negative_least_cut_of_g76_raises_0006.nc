(run with: --machine lathe2)
O1 (turning, threads: PS0006)
G97 S500 M03
G00 X64. Z2.
G76 P010060 Q-100 R.05 (expect alarm PS0006 at Q-100)
M30
