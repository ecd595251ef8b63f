' (run with: --param statement_limit=9)
n=0
loop: n=n+1
if n<100 then goto loop ' (expect alarm LB0023 at g)
' (finally n=3)
