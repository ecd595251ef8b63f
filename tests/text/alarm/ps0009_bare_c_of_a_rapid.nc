(run with: --machine lathe2)
O1 (PS0009: C is a chamfer of lines alone)
G98 G00 X20. Z0.
G00 X40. C2. (expect alarm PS0009 at C2.)
M30
