n=0
start: n=n+1
gosub count
if n<3 goto start
print n
end
count: local n
n=n+10
return
' (finally prints 3)
