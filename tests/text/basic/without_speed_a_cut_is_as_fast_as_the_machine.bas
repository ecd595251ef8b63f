power(10)
line(1,0) ' (expect assumed: no SPEED) (expect moves: line F6000)
line(2,0)
