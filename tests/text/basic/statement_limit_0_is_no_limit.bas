' (run with: --param statement_limit=0)
for i=1 to 20000
next
print i
' (finally prints 20001)
