(run with: --machine lathe2)
O1 (Measuring tools)
G00X100.Z5.
G36X50. (expect alarm PS0081)
M30
