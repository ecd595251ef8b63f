(run with: --set #11001=9000 --set #10001=9000)
O1 (PS0029: geometry and wear together are more than 9999.999)
G43 H1 Z10. (expect alarm PS0029)
M30
