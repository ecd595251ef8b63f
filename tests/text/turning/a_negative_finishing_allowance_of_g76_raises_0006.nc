(run with: --machine lathe2)
O1 (turning, threads: the passes would go deeper than the thread)
G97 S500 M03
G00 X64. Z2.
G76 P010060 Q100 R-.05 (expect alarm PS0006 at R-.05)
G76 X60. Z-20. P1300 Q350 F2.
M30
