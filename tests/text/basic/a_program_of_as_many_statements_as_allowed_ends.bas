' (run with: --param statement_limit=4)
a=1;b=2
if a then c=3
' (finally c=3)
