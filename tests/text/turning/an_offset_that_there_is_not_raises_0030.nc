(run with: --machine lathe2)
O1 (64 offsets)
T0165 (expect alarm PS0030 at T0165)
M30
