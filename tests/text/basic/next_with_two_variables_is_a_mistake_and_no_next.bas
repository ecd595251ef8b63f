for i=1 to 3
x=x+1 ' (expect warning LW0001 at x)
next i j ' (expect alarm LB0001 at j)
' (finally x=1)
