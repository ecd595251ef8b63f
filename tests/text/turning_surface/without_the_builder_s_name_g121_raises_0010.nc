(run with: --machine lathe3c --param stroke_check=0)
O1 (Polar interpolation by a name that this machine has not)
G98
G00X-20.Z2.C0
G121 (expect alarm PS0010 at G121)
M30
