' (run with: --param statement_limit=5)
a=1
b=2
c=3;d=4
e=5
f=6 ' (expect alarm LB0023 at f)
g=7
' (finally e=5)
