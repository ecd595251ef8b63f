(run with: --machine lathe2)
O1 (Measuring tools)
G00X100.Z5.T0101
G36Z5. (expect alarm PS0083)
M30
