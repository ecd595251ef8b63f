(run with: --machine lathe2 --skip-at X=50)
O1 (Measuring tools)
G00X60.Z5.T0101
G36X50. (expect moves: probe X50 F100)
M30
