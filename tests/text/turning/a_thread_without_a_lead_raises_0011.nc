(run with: --machine lathe2)
O1 (turning, threads: F is the lead)
G97 S500 M03
G00 X64. Z2.
G76 P010060 Q100 R.05
G76 X60. Z-20. P1300 Q350 (expect alarm PS0011)
M30
