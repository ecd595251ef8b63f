(run with: --set #13001=5)
O1 (PS0034: compensation starts on a line)
G42 D1 G03 X5. Y5. R5. F100 (expect alarm PS0034)
M30
