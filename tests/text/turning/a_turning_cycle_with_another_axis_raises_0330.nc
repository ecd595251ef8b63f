(run with: --machine lathe3c)
O1 (turning, single cycles: PS0330)
G97 S500 M03
G00 X64. Z2.
G90 X60. Z-5. C10. F.1 (expect alarm PS0330 at C10.)
M30
