(run with: --set #13001=1)
O1 (PS0039: a corner radius in the start-up block)
G41 D1 G01 X10. F100 ,R2. (expect alarm PS0039)
Y10.
M30
