(run with: --machine lathe2 --skip-at X=62)
O1 (Measuring tools)
G00X100.Z5.T0101
G36X50. (expect alarm PS0080)
M30
